function found = whirl_bearing(file)
% WHIRL_BEARING  Computes a journal bearing without a rotor over load and speed, as `whirl bearing` does.
%   FOUND = WHIRL_BEARING(FILE) takes the name of a file on a bearing (guide, chapter 15), or a struct with the content
%   of such a file, in SI and radians: arrays for its lists of numbers, a cell of structs for pads.
%
%   FOUND is the document of `whirl bearing --json`: points (a struct for each point: speed, load, sommerfeld,
%   eccentricity_ratio, attitude, film, pressure, flow, power, stiffness and damping [2][2], error, warnings), and with
%   tilting pads reduced (a struct for each whirl ratio), full and pads of every point. Its statements and sheets are
%   those that the command prints, in the units that the key units of the file chooses ('US').
%
%   Errors: whirl:badInput for a file that is wrong, with its line and key; whirl:noCommand.
%
%   See also WHIRL_RUN.
if nargin < 1
    file = [];
end
found = document_of('bearing', file, 'a file on a bearing', tempdir(), ' --quiet');
end
