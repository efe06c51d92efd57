function found = whirl_bearing(file)
% WHIRL_BEARING  Computes a journal bearing by itself over load and speed, as `whirl bearing` does.
%   FOUND = WHIRL_BEARING(FILE) takes the name of a file on a bearing (guide, chapter 15), or a struct of what it would
%   say, in SI and radians: arrays for its lists of numbers, a cell of structs for pads.
%
%   FOUND is the document of `whirl bearing --json`: points (a struct a point: speed, load, sommerfeld,
%   eccentricity_ratio, attitude, film, pressure, flow, power, stiffness and damping [2][2], error, warnings), and of
%   tilting pads reduced (a struct a whirl ratio), full and pads of every point.
%
%   Errors: whirl:badInput for a file that is wrong, with its line and key; whirl:noCommand.
%
%   See also WHIRL_RUN.
if nargin < 1 || (~isstruct(file) && ~is_text(text_of(file)))
    error('whirl:badInput', 'whirl_bearing takes the name of a file on a bearing, or a struct of what it would say');
end
if ~isstruct(file)
    found = jsondecode(answer(['bearing ' quoted(file_of(text_of(file))) ' --json --quiet']));
    return
end
if ~isfield(file, 'bearing')
    file.bearing = 1;
end
kept = [tempname() '.yaml'];
stream = fopen(kept, 'w');
if stream < 0
    error('whirl:failed', 'cannot write %s, expected a folder that may be written to', kept);
end
fwrite(stream, jsonencode(file));   % JSON is YAML
fclose(stream);
try
    found = jsondecode(answer(['bearing ' quoted(kept) ' --json --quiet']));
catch problem
    delete(kept);
    rethrow(problem);
end
delete(kept);
end
