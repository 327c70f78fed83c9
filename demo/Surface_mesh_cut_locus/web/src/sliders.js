// A row for each threshold: its name, a slider, a number, and, if the library has a default of its own, a box for it.

const scales = {
  linear: { to: (x) => x, from: (x) => x },
  log: { to: Math.exp, from: Math.log },
};

const digits = 3;

export class Slider {
  constructor({ id, methods, label, hint, min, max, initial, step = 0.001, scale = 'linear', automatic = '', ends = null, unit = '' }, onInput) {
    this.scale = scales[scale];
    this.automaticLabel = automatic;
    this.initial = initial;
    this.methods = methods; // that have it
    this.unit = unit;
    this.onInput = onInput;
    this.row = document.createElement('div');
    this.row.className = 'slider';
    this.row.title = hint;
    this.row.innerHTML = `
      <label for="${id}">${label}</label>
      <input type="range" id="${id}">
      <input type="number" id="${id}-number" aria-label="${label}">
      ${automatic ? `<label class="automatic"><input type="checkbox" id="${id}-auto">${automatic}</label>` : ''}
      ${ends ? `<span class="ends"><small>${ends[0]}</small><small>${ends[1]}</small></span>` : ''}
      <small class="note" id="${id}-note" hidden></small>`;
    const [range, number, box] = this.row.querySelectorAll('input');
    this.range = range;
    this.number = number;
    this.automatic = box; // if there is a default
    this.note = /** @type {HTMLElement} */ (this.row.querySelector('.note'));
    const position = this.scale.from;
    Object.assign(this.range, { min: position(min), max: position(max), step });
    Object.assign(this.number, { min, max, step: scale === 'log' ? 'any' : step });
    this.clamp = (x) => Math.min(Math.max(x, min), max);

    this.range.addEventListener('input', () => this.input(this.scale.to(Number(this.range.value)), this.range));
    this.number.addEventListener('input', () => {
      if (this.number.value !== '' && this.number.validity.valid) this.input(Number(this.number.value), this.number);
    });
    // what is out of the range becomes its end
    this.number.addEventListener('change', () => {
      const value = this.number.valueAsNumber;
      if (Number.isFinite(value) && this.clamp(value) !== value) this.input(value, this.number);
      this.set(this.value);
    });
    if (this.automatic)
      this.automatic.addEventListener('change', () => {
        this.set(this.automatic.checked ? null : this.shown());
        this.onInput(this.value);
      });
    this.set(automatic ? null : initial);
  }

  shown() {
    return Number(this.scale.to(Number(this.range.value)).toPrecision(digits));
  }

  input(value, by) {
    this.value = this.clamp(Number(value.toPrecision(by === this.range ? digits : 12)));
    if (this.automatic) this.automatic.checked = false;
    this.row.classList.remove('is-automatic');
    if (by !== this.range) this.range.value = this.scale.from(this.value);
    if (by !== this.number) this.number.value = this.value;
    this.tell(this.value);
    this.onInput(this.value);
  }

  // null is the default
  set(value) {
    this.value = value === null && !this.automatic ? this.initial : value;
    const shown = this.value === null ? this.initial : this.value;
    if (this.automatic) this.automatic.checked = this.value === null;
    this.row.classList.toggle('is-automatic', this.value === null);
    this.range.value = this.scale.from(this.clamp(shown));
    this.number.value = Number.isFinite(shown) ? String(Number(shown.toPrecision(digits))) : '';
    this.tell(this.number.value);
  }

  // The range has a scale of its own: readers of the screen are told the number.
  tell(value) {
    this.range.setAttribute('aria-valuetext', value === '' ? 'automatic' : `${value}${this.unit}`);
  }

  // what the default is on this mesh, where the library tells it; not a number if it has no place on the scale
  setInitial(value, note = '') {
    this.initial = value;
    this.note.textContent = note;
    this.note.hidden = note === '';
    if (this.value === null) this.set(null);
  }
}

const exact = ['default', 'polyhedral'], laplacian = ['laplacian'];

export const thresholds = [
  { id: 'width', methods: exact, isDetail: true, label: 'Detail: width, %', min: 0.01, max: 50, scale: 'log', initial: 1,
    automatic: 'auto', unit: ' % of the diagonal', ends: ['more branches', 'fewer branches'],
    hint: 'How far apart the two shortest paths to a branch must be somewhere, in percent of the diagonal of the '
      + 'bounding box: branches around what is smaller are left out. A smaller width gives more branches' },
  { id: 'angle', methods: laplacian, isDetail: true, label: 'Detail: angle', min: 0, max: 3.14, step: 0.01, initial: 0.7, automatic: 'auto', unit: ' radians', ends: ['more branches', 'fewer branches'],
    hint: 'The least angle at which shortest paths meet, in radians: a larger one removes weak branches' },
  { id: 'laplacian', methods: laplacian, label: 'Laplacian', min: -1, max: 3, step: 0.01, initial: -1, automatic: 'off',
    hint: 'The least value of minus the Laplacian of the distance, times the mean edge length' },
  { id: 'minimumEdges', methods: laplacian, label: 'Branch edges', min: 0, max: 100, step: 1, initial: 3,
    hint: 'Branches of fewer edges are removed' },
  { id: 'minimumLength', methods: laplacian, label: 'Branch length', min: 0, max: 0.5, step: 0.001, initial: 0,
    hint: 'Shorter branches are removed; in diagonals of the bounding box' },
  { id: 'smoothing', methods: laplacian, label: 'Smoothing', min: 0, max: 10, step: 1, initial: 4,
    hint: 'Steps that move the curve off the edges of the mesh, onto the cut locus: 4 are enough' },
];
