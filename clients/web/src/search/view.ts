import { h } from '../dom'
import type { View } from '../view'
import type { Workspace } from '../workspace'

export class SearchView implements View {
  readonly element = h('div', {}, h('h1', {}, 'Search'))

  constructor(private readonly workspace: Workspace) {}

  show(): void {
    void this.workspace
  }
  hide(): void {}
}
