// What a person would object to in a page as it is laid out: text that is cut, leaves its box or is covered, controls that lie on
// each other, a page that scrolls sideways. Runs in the page.

export function layoutFaults() {
  const SLACK_PX = 2
  const LONG_WORD = 24 // letters, from where it may be broken
  const root = document.querySelector('dialog[open]') ?? document.body
  const faults = []
  const styles = new Map()
  const styleOf = (element) => {
    if (!styles.has(element)) styles.set(element, getComputedStyle(element))
    return styles.get(element)
  }
  const isShown = (element) =>
    element.checkVisibility({ visibilityProperty: true, opacityProperty: true }) &&
    !element.closest('[class*=unseen]') &&
    element.getBoundingClientRect().right > 0 // a link that is left of the page until it has the focus
  const nameOf = (element) => {
    const words = (element.getAttribute('aria-label') ?? element.textContent ?? '').trim().replace(/\s+/g, ' ')
    return `<${element.localName}> “${words.slice(0, 60)}”`
  }
  /// As WCAG 2.2 has it, of two opaque colours.
  const contrast = (...colours) => {
    const light = colours.map((colour) => {
      const parts = colour
        .match(/[\d.]+/g)
        .slice(0, 3)
        .map((part) => part / 255)
      const [red, green, blue] = parts.map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4))
      return 0.2126 * red + 0.7152 * green + 0.0722 * blue + 0.05
    })
    return Math.max(...light) / Math.min(...light)
  }
  const isInline = (element) => ['inline', 'contents'].includes(styleOf(element).display)
  /// The part of `box` that is seen; what cannot be scrolled into sight is a fault. Null: it is scrolled out of sight.
  const clipped = (box, element, fault) => {
    let seen = box
    for (let around = element; around && around !== document.documentElement; around = around.parentElement) {
      const { overflowX, overflowY, position } = styleOf(around)
      if (overflowX !== 'visible' && !isInline(around)) {
        const edge = around.getBoundingClientRect()
        const isScroller = around.matches('[tabindex="0"]') // by the keyboard, too: it says that it is one
        const isWhole = seen.left >= edge.left - SLACK_PX && seen.right <= edge.right + SLACK_PX
        const isTold = styleOf(around).textOverflow === 'ellipsis' && around.title !== ''
        if (
          !isWhole &&
          !isScroller &&
          !isTold &&
          !around.matches('[data-part=labels], [data-part=hooks], [data-part=handles]')
        )
          fault('is cut at the side')
        const isTall = seen.top < edge.top - SLACK_PX || seen.bottom > edge.bottom + SLACK_PX
        if (isTall && (overflowY === 'hidden' || overflowY === 'clip')) fault('is cut above or below')
        seen = {
          left: Math.max(seen.left, edge.left),
          right: Math.min(seen.right, edge.right),
          top: Math.max(seen.top, edge.top),
          bottom: Math.min(seen.bottom, edge.bottom),
        }
        if (seen.right - seen.left < 1 || seen.bottom - seen.top < 1) return null
      }
      if (position === 'fixed') break
    }
    return seen
  }
  const boxed = (element) => {
    for (let around = element; around !== root.parentElement && around; around = around.parentElement) {
      const { borderTopWidth, borderTopStyle, backgroundColor } = styleOf(around)
      const isDrawn =
        (borderTopWidth !== '0px' && borderTopStyle !== 'none') || !/^rgba\(.*, 0\)$/.test(backgroundColor)
      if (isDrawn && !isInline(around)) return around
    }
    return root
  }

  const shown = [] // { box, element }
  const add = (element, box, isText) => {
    const said = new Set()
    const fault = (what) => said.add(what)
    const seen = clipped(box, element, fault)
    if (seen && isText) {
      const edge = boxed(element).getBoundingClientRect()
      const isIn =
        seen.left >= edge.left - SLACK_PX &&
        seen.right <= edge.right + SLACK_PX &&
        seen.top >= edge.top - SLACK_PX &&
        seen.bottom <= edge.bottom + SLACK_PX
      if (!isIn) fault(`leaves ${nameOf(boxed(element))}`)
    }
    for (const what of said) faults.push(`${nameOf(element)} ${what}`)
    if (seen) shown.push({ element, box: seen, isText })
  }

  const texts = document.createTreeWalker(root, NodeFilter.SHOW_TEXT)
  const range = document.createRange()
  for (let text = texts.nextNode(); text; text = texts.nextNode()) {
    const element = text.parentElement
    if (
      text.data.trim() === '' ||
      element.closest('script, style, option, canvas, noscript, textarea') ||
      !isShown(element)
    )
      continue
    range.selectNodeContents(text)
    const isWord = !/\s/.test(text.data.trim()) && text.data.trim().length < LONG_WORD
    if (isWord && new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size > 1)
      faults.push(`${nameOf(element)} is broken within a word`)
    for (const { left, right, top, bottom } of range.getClientRects())
      if (right - left > 1) add(element, { left, right, top, bottom }, true)
  }
  const pen = document.createElement('canvas').getContext('2d')
  for (const control of root.querySelectorAll('button, input, select, textarea, summary')) {
    if (!isShown(control) || control.closest('[data-part=hooks]')) continue
    const { left, right, top, bottom } = control.getBoundingClientRect()
    if (right - left < 1) continue
    add(control, { left, right, top, bottom }, false)
    const { color, backgroundColor } = styleOf(control)
    const isRead = control.localName !== 'select' || contrast(color, backgroundColor) >= 4.5 // axe looks at no list
    if (!isRead) faults.push(`${nameOf(control)} cannot be read`)
    const words =
      control.localName === 'select'
        ? control.selectedOptions[0]?.text
        : control.type === 'number'
          ? control.value || control.placeholder
          : ''
    if (!words) continue
    const { font, paddingLeft, paddingRight } = styleOf(control)
    pen.font = font
    const room =
      control.clientWidth -
      Number.parseFloat(paddingLeft) -
      Number.parseFloat(paddingRight) -
      (control.localName === 'select' ? 16 : 0)
    if (pen.measureText(words).width > room + SLACK_PX && control.title === '')
      faults.push(
        `${control.localName} “${words}” is cut: ${Math.round(pen.measureText(words).width)} px in ${Math.round(room)} px`,
      )
  }

  const overlap = (a, b) =>
    Math.min(a.right, b.right) - Math.max(a.left, b.left) > SLACK_PX &&
    Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > SLACK_PX
  for (const [i, a] of shown.entries())
    for (const b of shown.slice(i + 1))
      if (overlap(a.box, b.box) && !a.element.contains(b.element) && !b.element.contains(a.element))
        faults.push(`${nameOf(a.element)} and ${nameOf(b.element)} lie on each other`)
  for (const { element, box } of shown) {
    const [x, y] = [(box.left + box.right) / 2, (box.top + box.bottom) / 2]
    const hit = document.elementFromPoint(x, y)
    if (
      hit &&
      !hit.contains(element) &&
      !element.contains(hit) &&
      !element.closest('label')?.contains(hit) &&
      styleOf(element).pointerEvents !== 'none'
    )
      faults.push(`${nameOf(element)} is covered by ${nameOf(hit)}`)
  }
  const over = document.documentElement.scrollWidth - innerWidth
  if (over > 0) faults.push(`the page is ${over} px too wide`)
  return [...new Set(faults)]
}
