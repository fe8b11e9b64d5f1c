// A submerged dike at centrifuge scale, in metres: the cross-section from the middle of the crest to the
// toe. Change a number here, or in the scene under [geometry.parameters].
DefineConstant[
  length      = {0.48,  Name "Sea dike/length of the section, m"}
  height      = {0.25,  Name "Sea dike/height of the crest above the base, m"}
  crest_width = {0.15,  Name "Sea dike/width of the half crest, m"}
  toe_height  = {0.10,  Name "Sea dike/height of the ground before the toe, m"}
  slope       = {1.848, Name "Sea dike/slope, horizontal run for a rise of one"}
];

toe = crest_width + slope * (height - toe_height); // x of the toe of the slope, m

Point(1) = {0, 0, 0};
Point(2) = {length, 0, 0};
Point(3) = {length, toe_height, 0};
Point(4) = {toe, toe_height, 0};
Point(5) = {crest_width, height, 0};
Point(6) = {0, height, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};

Curve Loop(1) = {1, 2, 3, 4, 5, 6};
Plane Surface(1) = {1};

// The names that the scene refers to: a surface is a region of one material, a curve is a boundary.
Physical Surface("sand") = {1};
Physical Curve("base") = {1};
Physical Curve("right") = {2};
Physical Curve("surface") = {3, 4, 5}; // ground before the toe, slope, crest
Physical Curve("left") = {6};
