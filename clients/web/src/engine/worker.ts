// A thread of the engine in the page.
import { type Port, serve } from './serve'

serve(globalThis as unknown as Port)
