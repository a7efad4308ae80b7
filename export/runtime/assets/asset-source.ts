/** Loads the bytes of assets. */
export interface AssetSource {
  /** Loads a path of the program's asset table. Rejects with an `Error` whose message is text for the user. */
  load(path: string): Promise<ArrayBuffer>;
}

/** Assets on a server: paths are relative to `baseUrl`. */
export function createFetchAssetSource(baseUrl: string, fetchFile: typeof fetch): AssetSource {
  return {
    load: async (path) => {
      const address = path.split('/').map(encodeURIComponent).join('/');
      const response = await fetchFile(new URL(address, baseUrl).href).catch(() => null);
      if (!response) throw new Error('the server did not answer');
      if (!response.ok) throw new Error(response.status === 404 ? 'there is no such file' : `the server answered ${response.status}`);
      return response.arrayBuffer();
    },
  };
}
