import { h } from '../dom'
import type { View } from '../view'
import type { Workspace } from '../workspace'

export class StudiesView implements View {
  readonly element = h('div', {}, h('h1', {}, 'Studies'))

  constructor(private readonly workspace: Workspace) {}

  show(): void {
    void this.workspace
  }
  hide(): void {}
}
