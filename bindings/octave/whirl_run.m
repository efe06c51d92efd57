function result = whirl_run(given_case, varargin)
% WHIRL_RUN  Runs the study of a case and reads its result.
%   RESULT = WHIRL_RUN(CASE) computes the case file CASE, or the text of a case, and returns a struct as WHIRL_READ
%   does.
%
%   RESULT = WHIRL_RUN(CASE, NAME, VALUE, ...) sets parameters or keys of the case first, as the command's --set:
%   a number or a text, WHIRL_RUN('rig.yaml', 'kappa', 12, 'omega', '600 rpm'). These names are options:
%
%     'output'    name of the result file to keep; an existing file is an error. Without it a file for figures is kept
%                 until eight more runs have finished or the session ends
%     'overwrite' true or false: an existing 'output' is replaced (default: false)
%     'threads'   number of threads (default: all cores)
%     'progress'  true or false: the command's output is shown (default: true)
%
%   Errors: whirl:badInput with the sentences of the command, whirl:failed, whirl:noCommand. A run that was stopped
%   gives a partial result and the warning whirl:unfinished.
%
%   See also WHIRL_READ, WHIRL_MACHINE.
if nargin > 0
    given_case = text_of(given_case);
end
if nargin < 1 || ~ischar(given_case) || mod(numel(varargin), 2) ~= 0
    error('whirl:badInput', 'whirl_run takes a case and pairs of names and values');
end
output = '';
overwrite = false;
shown = true;
arguments = '';
for i = 1:2:numel(varargin)
    name = text_of(varargin{i});
    value = text_of(varargin{i + 1});
    if strcmp(name, 'output')
        if ~is_text(value)
            error('whirl:badInput', '''output'' takes the name of a result file, a text');
        end
        output = value;
    elseif strcmp(name, 'overwrite')
        overwrite = truth(name, value);
    elseif strcmp(name, 'progress')
        shown = truth(name, value);
    elseif strcmp(name, 'threads')
        if ~isnumeric(value) || numel(value) ~= 1
            error('whirl:badInput', '''threads'' takes a number');
        end
        arguments = [arguments ' --threads=' sprintf('%d', value)];
    else
        arguments = [arguments ' --set ' quoted(setting(name, value))];
    end
end
kept = ~isempty(output);
if kept && ~overwrite && exist(file_of(output), 'file') == 2
    error('whirl:badInput', '''%s'' is there already and is kept: ''overwrite'', true replaces it', output);
end
if ~kept
    output = [tempname() '.h5'];
end
file = given_case;
written = any(given_case == 10);
if written
    file = [tempname() '.yaml'];
    stream = fopen(file, 'w');
    fwrite(stream, given_case);
    fclose(stream);
end
if ~kept || overwrite
    arguments = [arguments ' --force'];
end
if ~shown
    arguments = [arguments ' --quiet'];
end
try
    status = call(['run ' quoted(file_of(file)) ' -o ' quoted(file_of(output)) arguments], shown);
    result = whirl_read(output);
    if ~kept
        keep_file(output); % from which figures are drawn
    end
catch problem
    remove(written, file);
    remove(~kept, output);
    rethrow(problem);
end
remove(written, file);
if status == 3
    warning('whirl:unfinished', 'the run ended before its last point');
end
end

function value = truth(name, value)
if ~(islogical(value) || isnumeric(value)) || numel(value) ~= 1
    error('whirl:badInput', '''%s'' takes true or false', name);
end
end

function remove(wanted, file)
if wanted && exist(file, 'file')
    delete(file);
end
end
