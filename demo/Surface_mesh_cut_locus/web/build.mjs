// Bundles the page: build.mjs MODULE_FOLDER OUTPUT_FOLDER, where the first has cut_locus.js and cut_locus.wasm. As the page
// is free software, it comes with its license, its source, and notices of all that is inside.
import { execFile } from 'node:child_process';
import { cp, mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { build } from 'esbuild';

const [moduleFolder, output] = process.argv.slice(2).map((folder) => resolve(folder));
const web = dirname(fileURLToPath(import.meta.url));
const source = join(web, 'src');
const root = join(web, '../../..');
/** @type {import('esbuild').BuildOptions} */
const options = {
  bundle: true, minify: true, sourcemap: true, legalComments: 'none', metafile: true, outdir: output, target: 'es2021', logLevel: 'warning', absWorkingDir: web,
};

await mkdir(output, { recursive: true });
// parts that are loaded when they are needed are named by what is in them
for (const name of await readdir(output)) if (/\.js(\.map)?$/.test(name)) await rm(join(output, name));
const results = [
  await build({ ...options, entryPoints: [join(source, 'main.js')], format: 'esm', splitting: true }),
  await build({ ...options, entryPoints: [join(source, 'worker.js')], format: 'iife' }),
];
for (const name of ['cut_locus.js', 'cut_locus.wasm']) await cp(join(moduleFolder, name), join(output, name));
await cp(join(source, 'style.css'), join(output, 'style.css'));
await cp(join(root, 'LICENSE'), join(output, 'LICENSE.txt'));

const [, version] = (await readFile(join(root, 'CMakeLists.txt'), 'utf8')).match(/project\(Surface_mesh_cut_locus VERSION ([\d.]+)/);
const page = await readFile(join(source, 'index.html'), 'utf8');
const figure = await readFile(join(source, 'figure.svg'), 'utf8');
await writeFile(join(output, 'index.html'), page.replace('%VERSION%', version).replace('%FIGURE%', () => figure));

// of the packages that are really in the bundles
const packages = new Set(results.flatMap(({ metafile }) => Object.keys(metafile.inputs))
  .map((path) => path.match(/node_modules\/((?:@[^/]+\/)?[^/]+)\//)).filter(Boolean).map(([, name]) => name));
const notices = [await readFile(join(source, 'notices.txt'), 'utf8')];
for (const name of [...packages].sort()) {
  const folder = join(web, 'node_modules', name);
  const { license, homepage } = JSON.parse(await readFile(join(folder, 'package.json'), 'utf8'));
  const text = await readFile(join(folder, 'LICENSE'), 'utf8');
  notices.push(`${name}: ${license}${homepage ? `, ${homepage}` : ''}\n\n${text.trim()}\n\n`);
}
await writeFile(join(output, 'notices.txt'), notices.join('\n'));

const parts = ['LICENSE', 'README.md', 'CHANGES.md', 'CMakeLists.txt', 'CMakePresets.json', 'cmake', 'include', 'include_np', 'helpers',
  'demo/Surface_mesh_cut_locus', 'scripts'];
await promisify(execFile)('tar', ['-czf', join(output, 'source.tar.gz'), '--exclude=node_modules', '-C', root, ...parts]);
