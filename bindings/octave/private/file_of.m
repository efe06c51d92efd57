function name = file_of(name)
% FILE_OF  The name of a file as the command takes it: one that begins with - is no option.
if ~isempty(name) && name(1) == '-'
    name = ['./' name];
end
end
