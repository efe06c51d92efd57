function status = call(arguments, shown)
% CALL  Runs the command with arguments (text, already quoted); its messages become an error if it fails.
%   With SHOWN its standard output goes to the command window. STATUS is 0, or 3 for a run that ended early.
complaints = [tempname() '.txt'];
line = [command() ' ' arguments ' 2>' quoted(complaints)];
if shown
    status = system(line);
else
    [status, ignored] = system(line); %#ok<ASGLU>
end
sentence = '';
if exist(complaints, 'file')
    sentence = strtrim(fileread(complaints));
    delete(complaints);
end
if status == 127
    error('whirl:noCommand', ...
        ['the command whirl is not found: put its folder on the PATH, or its name into the environment by ' ...
         'setenv(''WHIRL'', ...)']);
elseif status == 2
    error('whirl:badInput', '%s', sentence);
elseif status ~= 0 && status ~= 3
    error('whirl:failed', '%s', sentence);
end
end
