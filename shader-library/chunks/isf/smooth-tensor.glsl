// A Gaussian mean of the tensors along `stepUv`, one pixel apart: the structure tensor is smoothed where its direction could not be averaged.
vec4 smoothTensor(vec2 stepUv) {
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int i = -SMOOTH_REACH; i <= SMOOTH_REACH; i++) {
    float share = weight(i, SMOOTH_PX);
    vec2 uv = isf_FragNormCoord + float(i) * stepUv;
    sum += share * (PASSINDEX == 1 ? IMG_NORM_PIXEL(tensor, uv) : IMG_NORM_PIXEL(tensorAcross, uv));
    total += share;
  }
  return sum / total;
}
