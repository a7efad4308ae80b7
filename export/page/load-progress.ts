/**
 * `fetch` that counts what comes in, as a fraction of `expectedBytes`, which is what all of it will be together. Bytes count as
 * they come out of the browser, so that the sum is right whether the host compresses or not.
 */
export function countingFetch(fetchFile: typeof fetch, expectedBytes: number, onProgress: (fraction: number) => void): typeof fetch {
  let loaded = 0;
  const count = (chunk: Uint8Array, controller: TransformStreamDefaultController<Uint8Array>) => {
    loaded += chunk.length;
    onProgress(Math.min(1, loaded / expectedBytes));
    controller.enqueue(chunk);
  };
  return async (input, init) => {
    const response = await fetchFile(input, init);
    if (!response.ok || !response.body) return response;
    const counted = response.body.pipeThrough(new TransformStream<Uint8Array, Uint8Array>({ transform: count }));
    return new Response(counted, { status: response.status, headers: response.headers });
  };
}
