// A column of the level ground of VELACS model 1, in metres of the full scale.
DefineConstant[
  width = {0.75, Name "Column/width, m"}
  depth = {10.0, Name "Column/depth of the sand, m"}
];

Point(1) = {0, 0, 0};
Point(2) = {width, 0, 0};
Point(3) = {width, depth, 0};
Point(4) = {0, depth, 0};

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
