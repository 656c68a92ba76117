// needs: sineBounded
// ((sin x + sin y + sin z) / 3)^2, in [0, 1]. Error 3e-7 up to 1e5 on every driver.
float leopard(vec3 p) {
    float mean = (sineBounded(p.x) + sineBounded(p.y) + sineBounded(p.z)) * (1.0 / 3.0);
    return mean * mean;
}
