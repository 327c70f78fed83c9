// Bundles the page: build.mjs MODULE_FOLDER OUTPUT_FOLDER, where the first has cut_locus.js and cut_locus.wasm.
import { cp, mkdir } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const [moduleFolder, output] = process.argv.slice(2);
const source = join(dirname(fileURLToPath(import.meta.url)), 'src');
const options = { bundle: true, minify: true, legalComments: 'linked', outdir: output, target: 'es2021', logLevel: 'warning' };

await mkdir(output, { recursive: true });
await build({ ...options, entryPoints: [join(source, 'main.js')], format: 'esm' });
await build({ ...options, entryPoints: [join(source, 'worker.js')], format: 'iife' });
for (const name of ['index.html', 'style.css']) await cp(join(source, name), join(output, name));
for (const name of ['cut_locus.js', 'cut_locus.wasm']) await cp(join(moduleFolder, name), join(output, name));
