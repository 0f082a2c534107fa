// 16-bit floats, IEEE 754-2008 binary16.
"use strict";
{
  const toNumber = (bits) => {
    const sign = bits & 0x8000 ? -1 : 1;
    const exponent = (bits >> 10) & 31;
    const fraction = bits & 1023;
    if (exponent === 31) return fraction ? NaN : sign * Infinity;
    return exponent === 0 ? sign * fraction * 2 ** -24 : sign * (1024 + fraction) * 2 ** (exponent - 25);
  };
  /// The number of each of the 65536 bit patterns.
  ajar.halfs = Float32Array.from({ length: 65536 }, (_, bits) => toNumber(bits));
}
