// Where a flat band lies that stands for a round yarn: 0 in the yarn's middle, 1 on the ridge of the side that is seen. In
// between, bends towards the viewer cover as much as those of the tube.
const float kTowardsRidge = 0.7;
