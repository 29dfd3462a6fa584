// Word of changes between the tabs of one browser.
export type Topic = 'kept plans' | 'valves' | 'jobs'

const channel = new BroadcastChannel('coapt')

export function tellTabs(topic: Topic): void {
  channel.postMessage(topic)
}

/// `changed` is called when another tab has changed what `topic` names.
export function onOtherTab(topic: Topic, changed: () => void): void {
  channel.addEventListener('message', ({ data }) => data === topic && changed())
}
