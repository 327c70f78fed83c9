// The elements of the page, by their names.

/**
 * @param {string} id
 * @returns {any} what kind of element it is stands in index.html
 */
export const element = (id) => document.getElementById(id);
