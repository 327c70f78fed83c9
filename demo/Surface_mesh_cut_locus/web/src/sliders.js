// A row for each threshold: its name, a slider, a number, and, if the library has a default of its own, a box for it.

const scales = {
  linear: { to: (x) => x, from: (x) => x },
  log: { to: Math.exp, from: Math.log },
};

export class Slider {
  constructor({ id, label, hint, min, max, step, scale = 'linear', initial, automatic, digits = 3 }, onInput) {
    this.scale = scales[scale];
    this.automaticLabel = automatic;
    this.initial = initial;
    this.digits = digits;
    this.onInput = onInput;
    this.row = document.createElement('div');
    this.row.className = 'slider';
    this.row.title = hint;
    this.row.innerHTML = `
      <label for="${id}">${label}</label>
      <input type="range" id="${id}">
      <input type="number" id="${id}-number" aria-label="${label}">
      ${automatic ? `<label class="automatic"><input type="checkbox" id="${id}-auto">${automatic}</label>` : ''}`;
    [this.range, this.number] = this.row.querySelectorAll('input');
    this.automatic = this.row.querySelector('[type=checkbox]');
    const position = this.scale.from;
    Object.assign(this.range, { min: position(min), max: position(max), step: scale === 'log' ? 0.001 : step });
    Object.assign(this.number, { min, max, step: scale === 'log' ? 'any' : step });
    this.clamp = (x) => Math.min(Math.max(x, min), max);

    this.range.addEventListener('input', () => this.input(this.scale.to(Number(this.range.value)), this.range));
    this.number.addEventListener('input', () => {
      if (this.number.value !== '' && this.number.validity.valid) this.input(Number(this.number.value), this.number);
    });
    this.number.addEventListener('change', () => this.set(this.value));
    if (this.automatic)
      this.automatic.addEventListener('change', () => {
        this.set(this.automatic.checked ? null : this.shown());
        this.onInput(this.value);
      });
    this.set(automatic ? null : initial);
  }

  shown() {
    return Number(this.scale.to(Number(this.range.value)).toPrecision(this.digits));
  }

  input(value, by) {
    this.value = this.clamp(Number(value.toPrecision(by === this.range ? this.digits : 12)));
    if (this.automatic) this.automatic.checked = false;
    this.row.classList.remove('is-automatic');
    if (by !== this.range) this.range.value = this.scale.from(this.value);
    if (by !== this.number) this.number.value = this.value;
    this.onInput(this.value);
  }

  // null is the default
  set(value) {
    this.value = value === null && !this.automatic ? this.initial : value;
    const shown = this.value === null ? this.initial : this.value;
    if (this.automatic) this.automatic.checked = this.value === null;
    this.row.classList.toggle('is-automatic', this.value === null);
    this.range.value = this.scale.from(this.clamp(shown));
    this.number.value = Number(shown.toPrecision(this.digits));
  }

  // what the default is on this mesh, where the library tells it
  setInitial(value) {
    this.initial = value;
    if (this.value === null) this.set(null);
  }
}

export const thresholds = {
  direction: [
    { id: 'strength', label: 'Strength', min: 2, max: 200, scale: 'log', initial: 3, automatic: 'auto',
      hint: 'By how many times the jump of the shortest paths across a branch must exceed what a smooth distance explains' },
  ],
  laplacian: [
    { id: 'angle', label: 'Angle', min: 0, max: 3.14, step: 0.01, initial: 0.7, automatic: 'auto',
      hint: 'The least angle at which shortest paths meet, in radians: a larger one removes weak branches' },
    { id: 'laplacian', label: 'Laplacian', min: -1, max: 3, step: 0.01, initial: -1, automatic: 'off',
      hint: 'The least value of minus the Laplacian of the distance, times the mean edge length' },
    { id: 'minimumEdges', label: 'Branch edges', min: 0, max: 100, step: 1, initial: 3,
      hint: 'Branches of fewer edges are removed' },
    { id: 'minimumLength', label: 'Branch length', min: 0, max: 0.5, step: 0.001, initial: 0,
      hint: 'Shorter branches are removed; in diagonals of the bounding box' },
    { id: 'smoothing', label: 'Smoothing', min: 0, max: 10, step: 1, initial: 4,
      hint: 'Steps that move the curve off the edges of the mesh, onto the cut locus: 4 are enough' },
  ],
};
