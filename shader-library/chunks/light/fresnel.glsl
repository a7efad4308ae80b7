// Reflectance of glass in air for unpolarized light: Fresnel's equations. Arguments: the cosine between normal and eye, and the index.
float fresnelAir(const in float cosine, const in float index) {
  float g = sqrt(max(index * index - 1.0 + cosine * cosine, 0.0));
  float s = (cosine - g) / (cosine + g);
  float p = (index * index * cosine - g) / (index * index * cosine + g);
  return 0.5 * (s * s + p * p);
}
