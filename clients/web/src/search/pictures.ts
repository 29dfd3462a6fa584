// Pictures of plans: fetched once, since images cannot carry a token, and given back when `signal` aborts.
import { getBlob } from '../api/http'
import { h } from '../dom'
import parts from '../style/parts.module.css'
import searchStyle from './search.module.css'

export class Pictures {
  private readonly urls = new Map<string, Promise<string>>()

  constructor(private readonly signal: AbortSignal) {
    signal.addEventListener('abort', () => {
      for (const url of this.urls.values()) url.then(URL.revokeObjectURL, () => {})
    })
  }

  /// Before and after, as the atrium sees it; says so where there is none.
  image(path: string, alt: string): HTMLElement {
    const image = h('img', { alt, width: 1300, height: 1210 })
    const frame = h('a', { class: searchStyle.picture, target: '_blank', title: 'Open at full size' }, image)
    const url = this.urls.get(path) ?? getBlob(path).then((blob) => URL.createObjectURL(blob))
    this.urls.set(path, url)
    url.then(
      (found) => {
        if (!this.signal.aborted) image.src = frame.href = found
      },
      () => frame.replaceChildren(h('p', { class: parts.hint }, 'The picture could not be loaded.')),
    )
    return frame
  }
}
