/** From the text in a page to arrays of numbers; the counterpart of `python/gantline/viewer/arrays.py`. */

import type { ArrayEntry, Header } from "./format";

export type Numbers = Float64Array | Float32Array | Uint32Array | Int32Array;

export interface Unpacked {
  header: Header;
  arrays: Map<string, Numbers>;
}

/** Bytes of a base64 text. */
function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let place = 0; place < text.length; place++) bytes[place] = text.charCodeAt(place);
  return bytes;
}

/** What zlib has compressed, by the browser itself. */
export async function inflate(bytes: Uint8Array<ArrayBuffer>): Promise<ArrayBuffer> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

/** Header and arrays of a packed recording. */
export async function unpack(headerText: string, dataText: string): Promise<Unpacked> {
  const header = JSON.parse(headerText) as Header;
  if (header.format !== 1) throw new Error(`a packed recording of format ${header.format} is not known here`);
  const data = await inflate(bytesOf(dataText.trim()));
  const arrays = new Map<string, Numbers>();
  for (const [name, entry] of Object.entries(header.arrays)) arrays.set(name, arrayOf(data, entry));
  return { header, arrays };
}

function arrayOf(data: ArrayBuffer, entry: ArrayEntry): Numbers {
  const count = entry.shape.reduce((product, size) => product * size, 1);
  switch (entry.type) {
    case "f8":
      return new Float64Array(data, entry.at, count);
    case "f4":
      return new Float32Array(data, entry.at, count);
    case "u4":
      return new Uint32Array(data, entry.at, count);
    case "steps":
      return summed(new Uint8Array(data, entry.at, 4 * count), entry.shape[0] ?? 0, count);
  }
}

/** Whole steps from the four planes of bytes of their changes. */
export function summed(planes: Uint8Array, rows: number, count: number): Int32Array {
  const values = new Int32Array(count);
  const width = rows > 0 ? count / rows : 0;
  for (let place = 0; place < count; place++) {
    const change =
      planes[place]! |
      (planes[place + count]! << 8) |
      (planes[place + 2 * count]! << 16) |
      (planes[place + 3 * count]! << 24);
    values[place] = change + (place >= width ? values[place - width]! : 0);
  }
  return values;
}
