// A cantilever four times as long as high, in metres.
DefineConstant[
  width  = {4.0, Name "Body/width, m"}
  height = {1.0, Name "Body/height, m"}
];

Point(1) = {0, 0, 0};
Point(2) = {0 + width, 0, 0};
Point(3) = {0 + width, 0 + height, 0};
Point(4) = {0, 0 + height, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};

Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

Physical Surface("body") = {1};
Physical Curve("bottom") = {1};
Physical Curve("right") = {2};
Physical Curve("top") = {3};
Physical Curve("left") = {4};
