// Before all other parts: the yarn is cut by the section plane, and its cut faces are shown.
#define CUT
