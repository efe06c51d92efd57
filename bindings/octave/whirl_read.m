function result = whirl_read(file)
% WHIRL_READ  Reads a result of whirl.
%   RESULT = WHIRL_READ(FILE) is a struct with all numbers of a result file (.h5), bit for bit, or of a MAT file that
%   'whirl export --mat' made from one:
%
%     result.sweep.values                           the parameter, in SI
%     result.sweep.orbit.max_radius                 [points][stations]
%     result.sweep.orbit.about.max_radius.unit      'length' (in length scales)
%     result.sweep.orbit.about.max_radius.SI_factor factor to metres
%     result.sweep.verdict.name                     verdicts in words
%     result.sweep.regime.confidence                and their confidence
%     result.sweep.attributes.parameter             the varied parameter
%     result.stations.name, result.parameters.name, .value, .unit
%     result.attributes.file                        file from which figures are drawn
%
%   Errors: whirl:badInput for a file that is no result, whirl:noCommand where the command is not found.
%
%   See also WHIRL_RUN, WHIRL_PLOT_BIFURCATION.
if nargin > 0
    file = text_of(file);
end
if nargin ~= 1 || ~ischar(file)
    error('whirl:badInput', 'whirl_read takes the name of a file');
end
if numel(file) > 4 && strcmp(file(end - 3:end), '.mat')
    if ~exist(file, 'file')
        error('whirl:badInput', 'there is no file %s', file);
    end
    about = dir(file);
    if numel(about) ~= 1 || about.bytes == 0   % load would wait for ever at a pipe or a device
        error('whirl:badInput', '%s holds nothing, expected a MAT file', file);
    end
    result = load(file);
    return
end
copy = [tempname() '.mat'];
call(['export ' quoted(file_of(file)) ' --mat ' quoted(copy)], false);
result = load(copy);
delete(copy);
if isempty(regexp(file, '^([/\\]|[A-Za-z]:)', 'once'))
    file = fullfile(pwd(), file);
end
result.attributes.file = file;
result.attributes.file_mark = file_mark(file);
end
