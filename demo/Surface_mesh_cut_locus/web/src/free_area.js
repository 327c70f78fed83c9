// Where there is room for the picture: what lies above it, as the result and the legend, leaves rectangles free.

const margin = 8; // pixels
const least = 0.3; // of the view along each side, whatever lies above it

// Each of the boxes is kept clear at one of the sides that it is near to. All boxes are of left, top, right, bottom,
// in pixels within the view.
export function freeAreas({ width, height }, boxes) {
  let areas = [{ left: 0, top: 0, right: width, bottom: height }];
  for (const box of boxes) {
    if (box.right <= 0 || box.left >= width || box.bottom <= 0 || box.top >= height) continue;
    areas = areas.flatMap((area) => {
      const cut = [
        box.top < height - box.bottom ? { ...area, top: Math.max(area.top, box.bottom + margin) }
          : { ...area, bottom: Math.min(area.bottom, box.top - margin) },
        box.left < width - box.right ? { ...area, left: Math.max(area.left, box.right + margin) }
          : { ...area, right: Math.min(area.right, box.left - margin) },
      ];
      return cut.filter((a) => a.right - a.left > least * width && a.bottom - a.top > least * height);
    });
  }
  return areas.length > 0 ? areas : [{ left: 0, top: 0, right: width, bottom: height }];
}

// Of several areas the one for which `scoreOf` its size is largest, and where its middle lies: from that of the view to
// the right and up, in parts of the view.
export function bestArea(view, boxes, scoreOf) {
  let best = null, most = -Infinity;
  for (const area of freeAreas(view, boxes)) {
    const size = { width: area.right - area.left, height: area.bottom - area.top };
    const score = scoreOf(size);
    if (score > most) {
      most = score;
      best = {
        ...size,
        shift: [(area.left + area.right) / 2 / view.width - 0.5, 0.5 - (area.top + area.bottom) / 2 / view.height],
      };
    }
  }
  return best;
}

const gap = 5; // pixels

// Of the corners of a view, the place of a square in the first one that no box covers, from the upper left one of the view; null
// if all are covered.
export function freeCorner({ width, height }, side, boxes) {
  const [left, right, top, bottom] = [gap, width - side - gap, gap, height - side - gap];
  const isFree = ([x, y]) => boxes.every((box) => box.right <= x || box.left >= x + side || box.bottom <= y || box.top >= y + side);
  return [[right, bottom], [left, bottom], [right, top], [left, top]].find(isFree) || null;
}
