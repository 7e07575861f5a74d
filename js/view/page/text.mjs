/** "three-quarter" as "Three-quarter". */
export const titled = (name) => name.charAt(0).toUpperCase() + name.slice(1);
