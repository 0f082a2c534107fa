// Unpacks pixels (`pack_pixels` in pixel_code.h), off the main thread where the browser allows it.
"use strict";
{
  /// base64 text → half floats, channels interleaved. Stands alone: its source is also the worker's.
  const decodePixels = async (text, channels) => {
    const binary = atob(text);
    const packed = new Uint8Array(binary.length);
    for (let i = 0; i < packed.length; ++i) packed[i] = binary.charCodeAt(i);
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    const planes = new Uint8Array(await new Response(stream).arrayBuffer());
    const count = planes.length / (2 * channels);
    const pixels = new Uint16Array(count * channels);
    for (let channel = 0; channel < channels; ++channel) {
      const low = 2 * count * channel;
      const high = low + count;
      let bits = 0;
      for (let i = 0; i < count; ++i) {
        const folded = planes[low + i] | (planes[high + i] << 8);
        bits = (bits + ((folded >> 1) ^ -(folded & 1))) & 0xffff;
        pixels[i * channels + channel] = bits;
      }
    }
    return pixels;
  };

  const workerSource = `const decodePixels = ${decodePixels};
    onmessage = async ({ data: { key, text, channels } }) => {
      try {
        const pixels = await decodePixels(text, channels);
        postMessage({ key, pixels }, [pixels.buffer]);
      } catch (error) {
        postMessage({ key, error: String(error) });
      }
    };`;

  const waiting = new Map();
  let nextKey = 0;

  const startWorker = () => {
    try {
      const worker = new Worker(URL.createObjectURL(new Blob([workerSource], { type: "text/javascript" })));
      worker.onmessage = ({ data }) => {
        const { resolve, reject } = waiting.get(data.key);
        waiting.delete(data.key);
        if (data.error) reject(new Error(data.error));
        else resolve(data.pixels);
      };
      return worker;
    } catch {
      return null;
    }
  };
  const worker = startWorker();

  ajar.decode = (text, channels) => {
    if (!worker) return decodePixels(text, channels);
    return new Promise((resolve, reject) => {
      const key = nextKey++;
      waiting.set(key, { resolve, reject });
      worker.postMessage({ key, text, channels });
    });
  };
}
