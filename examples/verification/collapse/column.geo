// A dry column between a wall on its right and the open side, on a floor that goes on, in metres.
DefineConstant[
  width  = {0.1, Name "Column/width, m"}
  height = {0.1, Name "Column/height, m"}
  floor_length = {0.4, Name "Floor/length ahead of the column, m"}
];

Point(1) = {0, 0, 0};
Point(2) = {width, 0, 0};
Point(3) = {width, height, 0};
Point(4) = {0, height, 0};
Point(5) = {-floor_length, 0, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(5) = {5, 1};

Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Physical Surface("sand") = {1};
Physical Curve("floor") = {5, 1};
Physical Curve("wall") = {2};
