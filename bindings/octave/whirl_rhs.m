function dxdt = whirl_rhs(machine, t, x)
% WHIRL_RHS  Evaluates the equations of motion of a rotor, in the form for ode45.
%   DXDT = WHIRL_RHS(M, T, X): X are x and y of every station in m, then their velocities in m/s; T in s. A rotor with
%   other states (tilts, turning phases, nodes of shafts) is refused.
%
%   [t, x] = ode45(@(t, x) whirl_rhs(m, t, x), [0 1], x0);
%
%   See also WHIRL_MACHINE, WHIRL_ELEMENT.
if nargin ~= 3
    error('whirl:badInput', 'whirl_rhs takes a machine, t and x');
end
dxdt = whirl_mex('rhs', number_of(machine), t, x);
end
