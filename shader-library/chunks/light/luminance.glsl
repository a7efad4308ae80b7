// Relative luminance of linear-sRGB (Rec. 709).
float luminance(const in vec3 color) {
  return dot(color, vec3(0.2126, 0.7152, 0.0722));
}
