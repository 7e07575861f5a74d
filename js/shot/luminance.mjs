/**
 * Relative luminance of linear Rec.709: the sum in this order, which server and browser share to the last bit. src: ITU-R BT.709-6, item 3.2
 * @param {ArrayLike<number>} data
 * @param {number} [at] where red stands in it
 */
export const luminance = (data, at = 0) => 0.2126 * data[at] + 0.7152 * data[at + 1] + 0.0722 * data[at + 2];
