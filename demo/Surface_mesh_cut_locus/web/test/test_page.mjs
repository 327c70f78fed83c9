// Drives the page in a browser as a user does:
//   test_page.mjs PAGE_FOLDER [--pictures FOLDER] [--meshes FOLDER] [--only PATTERN]
// Pictures of what is seen are written to the first folder; the mesh files of the second one are opened, cut and
// exported; PATTERN is a regular expression that the names of the tests to run match.
import { mkdir, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { openBrowser } from './browser.mjs';
import { patience, Driver } from './page_driver.mjs';
import { serve } from '../serve.mjs';
import * as accessibility from './cases/accessibility.mjs';
import * as exporting from './cases/exporting.mjs';
import * as files from './cases/files.mjs';
import * as firstScreen from './cases/first_screen.mjs';
import * as hosting from './cases/hosting.mjs';
import * as layout from './cases/layout.mjs';
import * as links from './cases/links.mjs';
import * as look from './cases/look.mjs';
import * as meshes from './cases/meshes.mjs';
import * as results from './cases/results.mjs';
import * as touch from './cases/touch.mjs';
import * as trouble from './cases/trouble.mjs';
import * as work from './cases/work.mjs';

const [pageFolder, ...rest] = process.argv.slice(2);
const options = {};
for (let i = 0; i < rest.length; i += 2) options[rest[i].replace(/^--/, '')] = rest[i + 1];

const scratch = await mkdtemp(join(tmpdir(), 'cut_locus_page_'));
const { server, address } = await serve(pageFolder);
const context = await openBrowser(join(scratch, 'profile'));
const page = context.pages()[0] || await context.newPage();
page.setDefaultTimeout(patience);
const pageErrors = [];
const requests = new Set();
page.on('pageerror', (error) => pageErrors.push(error.message));
page.on('request', (request) => requests.add(new URL(request.url()).origin));

// links are opened by who has been here
await page.addInitScript(() => { if (location.hash.length > 1) localStorage.setItem('cut-locus-intro', 'read'); });

const driver = new Driver({ page, address, scratch, pictureFolder: options.pictures });
const facts = { pageFolder, meshFolder: options.meshes, pageErrors, requests, address };
if (options.pictures) await mkdir(options.pictures, { recursive: true });
let failures = 0;
for (const { tests } of [firstScreen, results, work, touch, look, exporting, links, files, trouble, layout, accessibility, meshes, hosting])
  for (const [name, test] of Object.entries(tests)) {
    if (!name.match(options.only || '')) continue;
    const start = performance.now();
    try {
      // some tests go on where the last one has ended, unless they run alone
      if (page.url() === 'about:blank') await driver.open('#sample=torus&faces=5000');
      const note = await test(driver, facts);
      console.log(`ok      ${name} (${((performance.now() - start) / 1000).toFixed(1)} s)${note ? ` ${note}` : ''}`);
    } catch (error) {
      ++failures;
      console.log(`FAILED  ${name}\n${error.stack}`);
      if (options.pictures) await page.screenshot({ path: join(options.pictures, `failed_${failures}.png`) });
    }
  }
await context.close();
server.close();
await rm(scratch, { recursive: true, force: true });
console.log(failures === 0 ? 'The page: passed' : `The page: ${failures} tests failed`);
process.exit(failures === 0 ? 0 : 1);
