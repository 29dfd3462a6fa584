// What a thread of the engine is told, and what it says.
import type { SearchProgress } from '../api/types'
import type { LiveCommand, LiveReply } from './live_loop'
import type { EngineAnswer } from './module'
import type { TeamPlace } from './team'

export interface EngineRequest {
  path: string
  body: string
  place?: TeamPlace | undefined // of a search
}

/// The module, or why there is none, comes first. Each request gets one reply, in order.
export type ToThread = { module: WebAssembly.Module } | { missing: string } | EngineRequest | LiveCommand
export type EngineReply = EngineAnswer | { failed: string } | { progress: SearchProgress }
export type FromThread = EngineReply | LiveReply
