/**
 * How many bytes of graphics memory are worth one byte to download. At 4 Mbit/s a megabyte is two seconds of waiting; a phone's
 * page has some hundred megabytes of textures before it is ended. PNG textures always gain by KTX2 (they shrink, too); a JPEG of
 * 1,024 × 1,024 would grow from 150 kB to 1.1 MB for 4 MB of memory saved, and stays.
 */
export const GPU_BYTES_PER_FILE_BYTE = 8;

/**
 * What decoders add to a page, bytes as hosts send them (gzip -9, three r187): meshopt's is a part of the script; KTX2's are the loader,
 * the transcoder and its script.
 */
export const DECODER_BYTES = { meshopt: 7_300, ktx2: 287_000 } as const;
