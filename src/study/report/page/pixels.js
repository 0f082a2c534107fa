// Pixels of layers: loaded when needed through <script> elements (fetch is blocked on file://), kept up to a limit.
"use strict";
{
  /// Bytes of unpacked pixels kept in memory; the least recently used go first. 97 images of 1280 × 720 fit.
  const kLimit = 512 * 2 ** 20;

  const kept = new Map(); // file → {pixels, channels, width, height}, least recently used first
  const loading = new Map(); // file → promise
  const failed = new Map(); // file → message
  const receivers = new Map(); // file → function that takes the base64 text
  let bytes = 0;

  /// Called by the files in data/.
  ajar.receive = (file, text) => receivers.get(file)?.(text);

  const fetchText = (file) =>
    new Promise((resolve, reject) => {
      const script = ajar.element("script", { src: `data/${file}` });
      const done = () => {
        receivers.delete(file);
        script.remove();
      };
      receivers.set(file, resolve);
      script.onload = () => {
        done();
        reject(new Error(`data/${file} is damaged`)); // without effect if it has been received
      };
      script.onerror = () => {
        done();
        reject(new Error(`data/${file} is missing`));
      };
      document.head.append(script);
    });

  const keep = (file, entry) => {
    kept.set(file, entry);
    bytes += entry.pixels.byteLength;
    for (const [oldest, old] of kept) {
      if (bytes <= kLimit || oldest === file) break;
      kept.delete(oldest);
      bytes -= old.pixels.byteLength;
    }
  };

  const load = async (image, layer) => {
    const pixels = await ajar.decode(await fetchText(layer.file), layer.channels);
    if (pixels.length !== image.width * image.height * layer.channels) throw new Error(`data/${layer.file} is damaged`);
    keep(layer.file, { file: layer.file, pixels, channels: layer.channels, width: image.width, height: image.height });
  };

  /// The layer of that name, or undefined.
  ajar.layerOf = (image, name) => image.layers.find((layer) => layer.name === name);

  ajar.pixels = {
    /// What is in memory, or undefined; never waits.
    get(image, layerName) {
      const file = ajar.layerOf(image, layerName)?.file;
      const entry = kept.get(file);
      if (entry) {
        kept.delete(file);
        kept.set(file, entry);
      }
      return entry;
    },
    /// Whether it is in memory, without counting as use.
    has: (image, layerName) => kept.has(ajar.layerOf(image, layerName)?.file),
    /// Why it cannot be had, or undefined.
    failure: (image, layerName) => failed.get(ajar.layerOf(image, layerName)?.file),
    /// Resolves when it is in memory, or has failed, or does not exist.
    request(image, layerName) {
      const layer = ajar.layerOf(image, layerName);
      if (!layer || kept.has(layer.file) || failed.has(layer.file)) return Promise.resolve();
      if (!loading.has(layer.file)) {
        const promise = load(image, layer)
          .catch((error) => failed.set(layer.file, error.message))
          .then(() => loading.delete(layer.file));
        loading.set(layer.file, promise);
      }
      return loading.get(layer.file);
    },
    /// Whether one more image of that size can be loaded ahead of need without dropping another.
    hasRoom: (image) => bytes + 6 * image.width * image.height <= kLimit,
    usedBytes: () => bytes,
  };
}
