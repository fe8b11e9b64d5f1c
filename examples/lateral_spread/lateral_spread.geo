// A gentle slope of sand in a rigid container, in metres of the full scale. Change a number here, or in the scene
// under [geometry.parameters].
DefineConstant[
  length = {20.0, Name "Slope/length, m"}
  depth  = {4.0, Name "Slope/depth of the sand in the middle, m"}
  angle  = {5.0, Name "Slope/angle of the ground, degrees"}
];

half_rise = 0.5 * length * Tan(angle * Pi / 180);

Point(1) = {0, 0, 0};
Point(2) = {length, 0, 0};
Point(3) = {length, depth - half_rise, 0};
Point(4) = {0, depth + half_rise, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};

Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

// The names that the scene refers to: a surface is a region of one material, a curve is a boundary.
Physical Surface("sand") = {1};
Physical Curve("base") = {1};
Physical Curve("downhill") = {2};
Physical Curve("ground") = {3};
Physical Curve("uphill") = {4};
