// Light or dark: the colors are those of the style sheet, which the picture shares.

const preference = window.matchMedia('(prefers-color-scheme: dark)');

export const themes = ['auto', 'light', 'dark'];

export function applyTheme(choice) {
  const isDark = choice === 'dark' || (choice === 'auto' && preference.matches);
  document.documentElement.dataset.theme = isDark ? 'dark' : 'light';
}

export const onPreference = (action) => preference.addEventListener('change', action);

export function themeColors() {
  const style = getComputedStyle(document.documentElement);
  const color = (name) => style.getPropertyValue(`--${name}`).trim();
  const names = ['back', 'text', 'soft', 'off', 'line', 'card', 'source', 'curve', 'hidden', 'edges', 'nearest', 'arrows', 'path'];
  const isDark = document.documentElement.dataset.theme === 'dark';
  return {
    ...Object.fromEntries(names.map((name) => [name, color(name)])),
    surface: isDark ? [0.56, 0.59, 0.64] : [0.84, 0.86, 0.88],
    casing: isDark ? '#101317' : '#ffffff',
    isDark,
  };
}
