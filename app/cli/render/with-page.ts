import { bundleScript } from '../../services/bundle-script.ts';
import type { Chromium } from '../../services/chromium.ts';
import { startBrowser } from '../../services/start-browser.ts';
import { type RenderServer, startRenderServer } from './render-server.ts';

/** Functions that a page’s script exports. */
type PageApi<Api> = Record<keyof Api, (...args: never[]) => unknown>;

/** Calls a function of the page. Arguments and result are copied. */
export type CallPage<Api extends PageApi<Api>> = <K extends keyof Api>(
  name: K,
  ...args: Parameters<Api[K]>
) => Promise<Awaited<ReturnType<Api[K]>>>;

export interface PageOptions {
  /** Folder with the sources of Scrim. */
  readonly root: string;
  /** The page’s script, relative to `root`. */
  readonly entry: string;
  /** Real paths of the folders that the page may read, by the first part of their URL. */
  readonly folders: Readonly<Record<string, string>>;
}

const GLOBAL = 'scrimPage';

/** Loads a script into an empty page of a headless browser, runs `use`, and closes the browser and the server in all cases. */
export async function withPage<Api extends PageApi<Api>, Result>(
  found: Chromium,
  { root, entry, folders }: PageOptions,
  use: (call: CallPage<Api>, server: RenderServer) => Promise<Result>,
): Promise<Result> {
  const server = await startRenderServer({ script: await bundleScript(root, entry, GLOBAL), folders });
  try {
    const browser = await startBrowser(found);
    try {
      const page = await browser.newPage();
      await page.goto(server.url);
      const call: CallPage<Api> = (name, ...args) =>
        page.evaluate(
          ([global, n, a]) =>
            (globalThis as unknown as Record<string, Record<string, (...x: readonly unknown[]) => unknown>>)[global]?.[n]?.(...a),
          [GLOBAL, String(name), args as readonly unknown[]] as const,
        ) as Promise<never>;
      return await use(call, server);
    } finally {
      await browser.close();
    }
  } finally {
    await server.close();
  }
}
