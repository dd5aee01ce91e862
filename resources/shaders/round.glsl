// Before all other parts: the tube is round all around, never a ridge.
#define ROUND
