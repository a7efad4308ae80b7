import { resolve } from 'node:path';
import process from 'node:process';
import type { HostInput, HostMethod, HostOutput } from '../../app/contract/contract.ts';
import { outputOf } from '../../app/contract/host-error.ts';
import { type FileLayer, NODE_FILES } from '../../app/services/file-layer.ts';
import { createHost, type HostService } from '../../app/services/host.ts';
import { installationAt } from '../../app/services/installation.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const hosts: HostService[] = [];

/** Starts a host as in another process: it shares only the folder. */
export function startHost(files: FileLayer = NODE_FILES): HostService {
  const origins = { editor: 'http://127.0.0.1:1', preview: 'http://127.0.0.1:2' };
  const shell = {
    kind: 'server',
    origins,
    pickFolder: null,
    closeWindow: () => {},
    revealFile: null,
    openInBrowser: null,
    showMenus: null,
  } as const;
  const log = (text: string) => process.stderr.write(`${text}\n`);
  const host = createHost({ shell, installation: installationAt(ROOT, '0'), startPath: null, files, log });
  hosts.push(host);
  return host;
}

/** Opens a window of a host. It exists until it leaves. */
export function openWindow(host: HostService, name: string) {
  const leave = host.attend(name);
  const call = async <M extends HostMethod>(method: M, input: HostInput<M>): Promise<HostOutput<M>> =>
    outputOf(await host.dispatch(method, input, name)) as HostOutput<M>;
  return { call, leave };
}

/** Stops all started hosts. Resolves when they no longer write. */
export async function stopHosts(): Promise<void> {
  await Promise.all(hosts.splice(0).map((host) => host.dispose()));
}
