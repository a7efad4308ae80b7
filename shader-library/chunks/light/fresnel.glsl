// Part of unpolarized light that glass in air reflects: Fresnel's equations, for the cosine between normal and eye, and the glass's index.
float fresnelAir(const in float cosine, const in float index) {
  float g = sqrt(max(index * index - 1.0 + cosine * cosine, 0.0));
  float s = (cosine - g) / (cosine + g);
  float p = (index * index * cosine - g) / (index * index * cosine + g);
  return 0.5 * (s * s + p * p);
}
