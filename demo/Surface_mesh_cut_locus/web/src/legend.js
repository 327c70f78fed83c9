// Names what is on the screen: beside the picture, and in a picture that is saved.

const thickness = { line: 4, thin: 1 }; // of others 10

function bar(doc, { stops, ends }) {
  const row = doc.createElement('span');
  row.className = 'bar';
  const ramp = doc.createElement('i');
  ramp.style.background = `linear-gradient(90deg, ${stops.join(', ')})`;
  const [low, high] = ends.map((text) => Object.assign(doc.createElement('span'), { textContent: text }));
  row.append(low, ramp, high);
  return row;
}

export function fillLegend(element, items) {
  element.replaceChildren(...items.map((item) => {
    const row = document.createElement('span');
    const label = Object.assign(document.createElement('span'), { textContent: item.label });
    if (item.kind === 'scale') {
      row.className = 'scale';
      row.append(label, bar(document, item));
      return row;
    }
    const sign = document.createElement('i');
    if (item.kind === 'dot') {
      sign.className = 'dot';
      sign.style.borderColor = item.rim;
    }
    if (item.kind in thickness) sign.style.height = `${thickness[item.kind]}px`;
    sign.style.background = item.color;
    row.append(sign, label);
    return row;
  }));
}

const size = 13, lineHeight = 21, margin = 12;

// Into the lower left corner of a picture; lengths are those of the page, times `scale`.
export function drawLegend(context, items, { height, scale, colors }) {
  context.save();
  context.scale(scale, scale);
  context.font = `${size}px system-ui, "DejaVu Sans", sans-serif`;
  context.textBaseline = 'middle';
  const widthOf = (item) => 34 + context.measureText(item.label).width
    + (item.kind === 'scale' ? 120 + context.measureText(item.ends.join('')).width : 0);
  const width = Math.max(...items.map(widthOf)) + 14;
  const top = height / scale - margin - items.length * lineHeight - 8;
  context.fillStyle = colors.card;
  context.beginPath();
  context.roundRect(margin, top, width, items.length * lineHeight + 8, 7);
  context.fill();
  items.forEach((item, i) => {
    const y = top + 4 + (i + 0.5) * lineHeight;
    let x = margin + 10;
    const write = (text) => {
      context.fillStyle = colors.text;
      context.fillText(text, x, y);
      x += context.measureText(text).width + 6;
    };
    if (item.kind === 'scale') {
      write(item.label);
      write(item.ends[0]);
      const gradient = context.createLinearGradient(x, 0, x + 96, 0);
      item.stops.forEach((stop, k) => gradient.addColorStop(k / (item.stops.length - 1), stop));
      context.fillStyle = gradient;
      context.fillRect(x, y - 5, 96, 10);
      x += 102;
      write(item.ends[1]);
      return;
    }
    context.fillStyle = item.color;
    if (item.kind === 'dot') {
      context.beginPath();
      context.arc(x + 9, y, 5.5, 0, 2 * Math.PI);
      context.fill();
      context.strokeStyle = item.rim;
      context.stroke();
    } else {
      const thick = thickness[item.kind] || 10;
      context.fillRect(x, y - thick / 2, 20, thick);
    }
    x += 26;
    write(item.label);
  });
  context.restore();
}
