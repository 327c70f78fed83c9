// What ESLint checks: its own recommendations, and what keeps the code short and plain.
import js from '@eslint/js';
import globals from 'globals';

export default [
  js.configs.recommended,
  {
    rules: {
      eqeqeq: 'error',
      'no-var': 'error',
      'prefer-const': ['error', { destructuring: 'all' }],
      'prefer-arrow-callback': 'error',
      'object-shorthand': 'error',
      'no-else-return': 'error',
      'no-lonely-if': 'error',
      'no-shadow': 'error',
      'no-unneeded-ternary': 'error',
      'no-unused-expressions': 'error',
      'no-useless-concat': 'error',
      'no-implicit-globals': 'error',
      'no-throw-literal': 'error',
      'no-console': 'error',
      'max-lines': ['error', { max: 800 }],
    },
  },
  { files: ['src/*.js'], languageOptions: { globals: globals.browser } },
  { files: ['src/worker.js'], languageOptions: { globals: globals.worker } },
  { files: ['**/*.mjs'], languageOptions: { globals: { ...globals.node, ...globals.browser } }, rules: { 'no-console': 'off' } },
];
