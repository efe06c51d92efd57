function found = whirl_balance(file)
% WHIRL_BALANCE  Finds the weights that balance a rotor, or proposes trial weights, as `whirl balance` does.
%   FOUND = WHIRL_BALANCE(FILE) takes the name of a file on balancing (guide, chapter 14), or a struct of what it would
%   say, in SI and radians: structs for its keys, cells of structs for its lists.
%
%   FOUND is the document of `whirl balance --json`: correction (a struct a plane: moment in kg m, angle in rad, holes),
%   vibration (before and after, influence), sets (of modes), proposals (trial weights by the model, with sentences),
%   unbalance, grade, allowed, warnings. Names of planes that are none of Octave's are changed as jsondecode does.
%
%   Errors: whirl:badInput for a file that is wrong, with its line and key; whirl:noCommand.
%
%   See also WHIRL_RUN.
if nargin < 1 || (~isstruct(file) && ~is_text(text_of(file)))
    error('whirl:badInput', 'whirl_balance takes the name of a file on balancing, or a struct of what it would say');
end
if ~isstruct(file)
    found = jsondecode(answer(['balance ' quoted(file_of(text_of(file))) ' --json']));
    return
end
if ~isfield(file, 'balance')
    file.balance = 1;
end
kept = [tempname(pwd()) '.yaml'];   % here, where its model is looked for
stream = fopen(kept, 'w');
if stream < 0
    error('whirl:failed', 'cannot write %s, expected a folder that may be written to', kept);
end
fwrite(stream, jsonencode(file));   % JSON is YAML
fclose(stream);
try
    found = jsondecode(answer(['balance ' quoted(kept) ' --json']));
catch problem
    delete(kept);
    rethrow(problem);
end
delete(kept);
end
