% The peer Octave script: loops over one machine, as the authors of a paper would write it. Steps take so long that one
% revolution suffices to measure the speed; the first 20 give the end state.
1; % a script, not a file of functions
function dz = slope(t, z)
    r_k = 0.6; w = 0.2; r_m = 8.4; xi1 = 0.0157509; xi2 = 0.286154;
    rho = 0.08; G = 0.115976; S_f = 0.0045; r_delta = 1.2; r_ck = 10; f = 0.1;
    K1 = 1 / (2 * r_m * w^2); K2 = 1 / (4 * w^2);
    x1 = z(1); y1 = z(2); x2 = z(3); y2 = z(4); u2 = z(7); v2 = z(8);
    a = r_k + 1; b = r_k - 1; dx = x1 - x2; dy = y1 - y2;
    sx = (a + b * cos(2 * t)) * dx + b * sin(2 * t) * dy;
    sy = (a + b * cos(2 * t)) * dy + b * sin(2 * t) * dx;
    fx = 0; fy = 0; radius = sqrt(x1^2 + y1^2);
    if radius >= r_delta
        push = (1 - r_delta / radius) * r_ck / (r_m * w^2);
        fx = -push * (x1 - f * y1);
        fy = -push * (f * x1 + y1);
    end
    A = x2 - 2 * v2; B = y2 + 2 * u2; q = 1 - x2^2 - y2^2;
    alpha = atan2(-B, -A); across = y2 * cos(alpha) - x2 * sin(alpha);
    along = x2 * cos(alpha) + y2 * sin(alpha);
    g = 2 / sqrt(q) * (pi / 2 + atan(across / sqrt(q)));
    V = (2 + across * g) / q; S = along / (1 - along^2); K = -sqrt(A^2 + B^2) / q;
    px = K * (3 * x2 * V - sin(alpha) * g - 2 * cos(alpha) * S);
    py = K * (3 * y2 * V + cos(alpha) * g - 2 * sin(alpha) * S);
    dz = [z(5:8); -xi1 * z(5) - K1 * sx + rho * cos(t) + fx; -xi1 * z(6) - K1 * sy + rho * sin(t) + fy - G; ...
          -0.5 * xi2 * u2 + K2 * sx + S_f * px; -0.5 * xi2 * v2 + K2 * sy + S_f * py - G];
end

steps = 1024; h = 2 * pi / steps; z = [0; -0.1; 0; -0.1; 0; 0; 0; 0];
revolutions = 20; best = Inf;
for revolution = 1:revolutions
    start = cputime();
    for n = 0:steps - 1
        t = n * h;
        k1 = slope(t, z);
        k2 = slope(t + h / 2, z + h / 2 * k1);
        k3 = slope(t + h / 2, z + h / 2 * k2);
        k4 = slope(t + h, z + h * k3);
        z = z + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    end
    best = min(best, cputime() - start);
end
printf("Octave script\t%.6g\t%.13f\n", steps / best, z(1));
