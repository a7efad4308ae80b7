/**
 * `fetch` that counts what comes in. `expectedBytes` is what all of it will be together; where a host compresses, bytes count
 * as they come out of the browser, so the sum is right.
 */
export interface LoadProgress {
  readonly fetch: typeof fetch;
}

export function createLoadProgress(fetchFile: typeof fetch, expectedBytes: number, onProgress: (fraction: number) => void): LoadProgress {
  let loaded = 0;
  const count = (bytes: number) => {
    loaded += bytes;
    onProgress(expectedBytes === 0 ? 1 : Math.min(1, loaded / expectedBytes));
  };
  return {
    fetch: async (input, init) => {
      const response = await fetchFile(input, init);
      if (!response.ok || !response.body) return response;
      const counted = response.body.pipeThrough(
        new TransformStream<Uint8Array, Uint8Array>({
          transform: (chunk, controller) => {
            count(chunk.length);
            controller.enqueue(chunk);
          },
        }),
      );
      return new Response(counted, { status: response.status, headers: response.headers });
    },
  };
}
