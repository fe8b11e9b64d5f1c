// A column of sand in a laminar box, in metres: as modelled in the centrifuge. Change a number here, or in the scene
// under [geometry.parameters].
DefineConstant[
  width  = {0.0675, Name "Column/width, m"}
  height = {0.3175, Name "Column/height of the sand, m"}
];

Point(1) = {0, 0, 0};
Point(2) = {width, 0, 0};
Point(3) = {width, height, 0};
Point(4) = {0, height, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};

Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

// The names that the scene refers to: a surface is a region of one material, a curve is a boundary.
Physical Surface("sand") = {1};
Physical Curve("base") = {1};
Physical Curve("right") = {2};
Physical Curve("surface") = {3};
Physical Curve("left") = {4};
