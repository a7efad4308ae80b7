import { contextBridge, type IpcRendererEvent, ipcRenderer } from 'electron';
import type { HostEvent } from '../contract/contract.ts';
import { HOST_BRIDGE_NAME, type HostBridge } from '../contract/ipc-client.ts';
import { CALL_CHANNEL, EVENT_CHANNEL, LISTENING_CHANNEL } from './channels.ts';

// Entry of the sandboxed preload script. It forwards messages and gives the page no access to Electron itself.
const bridge: HostBridge = {
  call: (method, input) => ipcRenderer.invoke(CALL_CHANNEL, method, input),
  subscribe: (listener) => {
    const forward = (_event: IpcRendererEvent, hostEvent: HostEvent) => listener(hostEvent);
    ipcRenderer.on(EVENT_CHANNEL, forward);
    ipcRenderer.send(LISTENING_CHANNEL);
    return () => ipcRenderer.removeListener(EVENT_CHANNEL, forward);
  },
};
contextBridge.exposeInMainWorld(HOST_BRIDGE_NAME, bridge);
