function force = whirl_element(name, machine, t, x)
% WHIRL_ELEMENT  Returns the forces of one element of a case on the stations.
%   F = WHIRL_ELEMENT(NAME, M, T, X) are the forces in N, x and y of every station, of the element NAME ('film', or
%   'film[2]' for the second film of the case) in the state X (see WHIRL_RHS) at T. They give a script with equations of
%   its own an oil film or a rub. An element does not know the masses of stations: 'gravity' gives the force on a mass
%   of 1 kg.
%
%   See also WHIRL_MACHINE, WHIRL_RHS.
if nargin ~= 4
    error('whirl:badInput', 'whirl_element takes the name of an element, a machine, t and x');
end
force = whirl_mex('element', number_of(machine), text_of(name), t, x);
end
