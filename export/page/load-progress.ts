/** Wraps `fetch` to count received bytes. They are counted after decompression, so they match the sizes of the files. */
export function countingFetch(fetchFile: typeof fetch, onProgress: (loadedBytes: number) => void): typeof fetch {
  let loaded = 0;
  const count = (chunk: Uint8Array, controller: TransformStreamDefaultController<Uint8Array>) => {
    loaded += chunk.length;
    onProgress(loaded);
    controller.enqueue(chunk);
  };
  return async (input, init) => {
    const response = await fetchFile(input, init);
    if (!response.ok || !response.body) return response;
    const counted = response.body.pipeThrough(new TransformStream<Uint8Array, Uint8Array>({ transform: count }));
    return new Response(counted, { status: response.status, headers: response.headers });
  };
}

/** Formats progress with one unit for both numbers: `1.2 of 3.4 MB`. */
export function progressText(loadedBytes: number, totalBytes: number): string {
  const [unit, size, digits] = totalBytes < 1_000_000 ? ['kB', 1000, 0] : ['MB', 1_000_000, 1];
  const loaded = Math.min(loadedBytes, totalBytes) / size;
  return `${loaded.toFixed(digits)} of ${(totalBytes / size).toFixed(digits)} ${unit}`;
}
