// A picture of what is seen, of any size that the graphics card can draw, without its background if that is wished, and
// with the legend.
import { drawLegend } from './legend.js';

function largestSide(viewer) {
  const gl = viewer.renderer.getContext();
  return Math.min(gl.getParameter(gl.MAX_RENDERBUFFER_SIZE), gl.getParameter(gl.MAX_TEXTURE_SIZE));
}

// Lines and points are as thick, relative to the height, as on the screen.
export async function takePicture(viewer, { width, height, isTransparent, legend }) {
  const { renderer, size } = viewer;
  const panes = [viewer.model, viewer.plane];
  const shifts = panes.map((pane) => pane.shift);
  const ratio = renderer.getPixelRatio();
  const scale = height / size.height;
  const largest = largestSide(viewer);
  if (Math.max(width, height) > largest)
    throw new Error(`The graphics card draws pictures of at most ${largest} pixels along a side`);
  try {
    viewer.size = { width: width / scale, height: size.height };
    renderer.setPixelRatio(scale);
    renderer.setSize(viewer.size.width, viewer.size.height, false);
    // rounding must not change the number of pixels
    Object.assign(viewer.canvas, { width, height });
    for (const pane of panes) pane.shift = [0, 0]; // nothing but the legend lies above it
    viewer.draw(true, { isTransparent, hasAxes: viewer.hasAxes && !isTransparent, overlays: [] });
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    const context = canvas.getContext('2d');
    context.drawImage(viewer.canvas, 0, 0);
    if (legend && legend.length > 0) drawLegend(context, legend, { height, scale, colors: viewer.colors });
    return await new Promise((resolve) => { canvas.toBlob(resolve, 'image/png'); });
  } finally {
    viewer.size = size;
    panes.forEach((pane, i) => { pane.shift = shifts[i]; });
    renderer.setPixelRatio(ratio);
    viewer.resize();
  }
}
