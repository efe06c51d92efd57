% A rigid rotor in an oil film, written by hand and integrated by ode45; the force of the film comes from whirl.
%
%   m x'' = Fx + m rho w^2 cos(w t),   m y'' = Fy - m g + m rho w^2 sin(w t)
%
% The same motion by whirl's own equations is drawn for comparison. The case is cases/rigid-rotor.yaml (all in SI,
% numbers of order 1), whose station has 1 kg and turns at 1 rad/s.
if ~exist('given_case', 'var')
    given_case = 'rigid-rotor.yaml';
end
rho = 0.2;
sigma = 0.3;
s = 3;
machine = whirl_machine(given_case, 'rho', rho, 'sigma', sigma, 's', s);
by_hand = @(t, x) [x(3:4); whirl_element('film', machine, t, x) + [rho * cos(t); rho * sin(t) - 1 / s^2]];
by_whirl = @(t, x) whirl_rhs(machine, t, x);

options = odeset('RelTol', 1e-9, 'AbsTol', 1e-11);
start = [0.1; -0.2; 0; 0];
times = linspace(0, 8 * 2 * pi, 801);
[t, hand] = ode45(by_hand, times, start, options);
[t, whirl] = ode45(by_whirl, times, start, options);
difference = max(max(abs(hand - whirl)));
fprintf('largest difference over 8 revolutions: %.2g clearances\n', difference);
plot(hand(:, 1), hand(:, 2), 'b-');
axis equal;
xlabel('x in clearances');
ylabel('y in clearances');
