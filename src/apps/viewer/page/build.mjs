// Writes the page, three files, into a folder: npm run build -- --outdir=FOLDER
import { build } from "esbuild";
import { copyFile, mkdir, readFile } from "node:fs/promises";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const source = dirname(fileURLToPath(import.meta.url));
const option = process.argv.find((one) => one.startsWith("--outdir="));
if (!option) throw new Error("say where to: --outdir=FOLDER");
const folder = resolve(option.slice("--outdir=".length));

// The report's scripts come first, as they are: they share the global `ajar`, and cannot be modules.
const report = join(source, "../../../study/report/page");
const shared = ["base.js", "half.js", "colour.js", "shader.js"];
const texts = await Promise.all(shared.map((name) => readFile(join(report, name), "utf8")));

await mkdir(folder, { recursive: true });
await build({
  entryPoints: [join(source, "main.ts")],
  outfile: join(folder, "viewer.js"),
  bundle: true,
  format: "iife",
  target: "es2022",
  charset: "utf8",
  legalComments: "none",
  logLevel: "warning",
  banner: { js: texts.join("") },
});
for (const name of ["index.html", "viewer.css"]) await copyFile(join(source, name), join(folder, name));
