// Starts the page: puts the parts together, and listens to the keyboard, to files that are dropped and to the address.
import { Address } from './address.js';
import { App } from './app.js';
import { Crosshair } from './crosshair.js';
import { DragHint } from './drag_hint.js';
import { element } from './elements.js';
import { listenToKeys } from './keyboard.js';
import { Link } from './link.js';
import { Panel } from './panel.js';
import { samples } from './samples.js';
import { fromHash, toHash } from './state.js';
import { Store } from './store.js';
import { Viewer } from './viewer.js';

const isFirstScreen = location.hash.replace(/^#(embed)?/, '') === '';
const { state, ignored } = fromHash(location.hash);
const store = new Store(state);
const link = new Link(ignored);
const panel = new Panel();

let viewer;
try {
  viewer = new Viewer(element('canvas'), { model: element('model-view'), atlas: element('atlas-view') }, {
    onPick: (place, mode) => app.pick(place, mode || panel.mode),
    onHover: (place, at) => app.hover(place, at),
    onFollow: {
      start: (index) => app.follower.start(index),
      move: (locate) => app.follower.move(locate),
      end: () => app.follower.end(),
    },
    onLost: (isLost) => panel.setLost(isLost),
    overlays: ['tools', 'intro', 'result', 'legend', 'cut-info'].map(element),
  });
} catch (error) {
  panel.showMessage('This page needs WebGL 2, which this browser does not offer.');
  throw error;
}
const app = new App(viewer, panel, store, link);
panel.connect(app);
panel.setEmbedded(state.isEmbedded);

let saved = location.hash;
const address = new Address((hash) => {
  saved = hash;
  history.replaceState(null, '', hash);
});
function saveState() {
  if (!app.mesh) return;
  const seen = { ...store.state, view: viewer.getView() };
  address.set(toHash(seen));
  panel.setLink(toHash({ ...seen, isEmbedded: false }));
}
store.subscribe(saveState);
viewer.onMove = saveState;
window.addEventListener('pagehide', () => address.flush());

async function start() {
  const { sample, file, faces } = state;
  if (!sample) {
    if (!await app.openKept()) panel.invite(file);
    return;
  }
  const isKnown = samples.some(({ name }) => name === sample);
  if (!isKnown) link.add(`There is no sample of the name “${sample}”.`);
  await app.openSample(isKnown ? sample : samples[0].name, faces, true);
  if (isFirstScreen && app.isSolved) greet();
}

// Nobody has chosen anything yet: the wave says what there is to see, if things may move.
function greet() {
  new DragHint(viewer, element('drag-hint')).show();
  if (!window.matchMedia('(prefers-reduced-motion: reduce)').matches) app.wave.play();
}

window.addEventListener('hashchange', () => {
  if (location.hash === saved) return;
  location.reload();
});

element('copy-link').addEventListener('click', async () => {
  saveState();
  address.flush();
  try {
    await navigator.clipboard.writeText(location.href);
    panel.showMessage('The link is in the clipboard.', { isPlain: true });
  } catch {
    panel.showMessage('The link is in the address bar of the browser.', { isPlain: true });
  }
});

const crosshair = new Crosshair(viewer, element('crosshair'), element('crosshair-target'));
listenToKeys({ app, viewer, panel, crosshair });

const stage = document.body;
let depth = 0; // of the elements entered while a file is dragged
stage.addEventListener('dragenter', () => { ++depth; element('drop').hidden = false; });
stage.addEventListener('dragleave', () => { if (--depth <= 0) element('drop').hidden = true; });
stage.addEventListener('dragover', (event) => event.preventDefault());
stage.addEventListener('drop', async (event) => {
  event.preventDefault();
  depth = 0;
  element('drop').hidden = true;
  const [file, ...others] = event.dataTransfer.files;
  if (!file) return;
  await app.openFile(file);
  if (others.length > 0) panel.showMessage(`One mesh is shown at a time: this is “${file.name}”.`, { isPlain: true });
});

// for tests and for whoever looks at the page from the console
/** @type {any} */ (window).cutLocusPage = { app, viewer, panel, address };
start();
