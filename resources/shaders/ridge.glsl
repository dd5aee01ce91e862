// Before all other parts: two flat faces, from outline to ridge to outline, stand for the half of a round tube that is seen.
#define RIDGE
