// sRGB transfer functions (IEC 61966-2-1) with the constants of three r187. Shared text: see README.md.

// Linear light to the sRGB code value, both [0, 1]; negative input follows the straight part.
// The exponent 0.41666 stands for 1/2.4: less than 0.002 / 255 off.
float srgbFromLinear(float linear) {
  return linear <= 0.0031308 ? linear * 12.92 : pow(linear, 0.41666) * 1.055 - 0.055;
}

// Same per channel of linear Rec.709.
vec3 srgbFromLinear(vec3 linear) {
  return vec3(srgbFromLinear(linear.x), srgbFromLinear(linear.y), srgbFromLinear(linear.z));
}

// sRGB code value to linear light, both [0, 1].
float linearFromSrgb(float encoded) {
  return encoded <= 0.04045 ? encoded * 0.0773993808 : pow(encoded * 0.9478672986 + 0.0521327014, 2.4);
}

// Same per channel, giving linear Rec.709.
vec3 linearFromSrgb(vec3 encoded) {
  return vec3(linearFromSrgb(encoded.x), linearFromSrgb(encoded.y), linearFromSrgb(encoded.z));
}
