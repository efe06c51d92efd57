function found = whirl_balance(file)
% WHIRL_BALANCE  Finds the weights that balance a rotor, or proposes trial weights, as `whirl balance` does.
%   FOUND = WHIRL_BALANCE(FILE) takes the name of a file on balancing (guide, chapter 14), or a struct with the content
%   of such a file, in SI and radians: structs for its keys, cells of structs for its lists.
%
%   FOUND is the document of `whirl balance --json`: correction (a struct for each plane: moment in kg m, angle in rad,
%   holes), vibration (before and after, influence), sets (of modes), proposals (trial weights by the model, with
%   sentences), unbalance, grade, allowed, warnings. Its statements and sheets are those that the command prints, in the
%   units that the key units of the file chooses ('US'). Names of planes that are not valid in Octave are changed as
%   jsondecode does.
%
%   Errors: whirl:badInput for a file that is wrong, with its line and key; whirl:noCommand.
%
%   See also WHIRL_RUN.
if nargin < 1
    file = [];
end
found = document_of('balance', file, 'a file on balancing', pwd(), '');   % the folder of a relative path of a model
end
