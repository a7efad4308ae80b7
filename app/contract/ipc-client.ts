import type { Host, HostEvent, HostInput, HostMethod, HostOutput } from './contract.ts';
import { type Answer, outputOf } from './host-error.ts';

/** The interface that the preload script of Electron adds to the window as `HOST_BRIDGE_NAME`. It only forwards messages. */
export interface HostBridge {
  call(method: string, input: unknown): Promise<Answer<unknown>>;
  subscribe(listener: (event: HostEvent) => void): () => void;
}

export const HOST_BRIDGE_NAME = 'scrimHost';

/** The host behind the preload script of Electron. */
export function createIpcHost(bridge: HostBridge): Host {
  return {
    call: async <M extends HostMethod>(method: M, input: HostInput<M>) =>
      outputOf((await bridge.call(method, input)) as Answer<HostOutput<M>>),
    subscribe: (listener) => bridge.subscribe(listener),
  };
}
