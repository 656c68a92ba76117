// needs:
// Arc sine for |x| <= 1/2. Relative error 1.5e-7.
float arcSmall(float x) {
    float square = x * x;
    return x + x * square * (0.166668215 +
        square * (0.0749307733 + square * (0.0457077717 + square * (0.0231423538
             + square * 0.0437629344))));
}
