function text = answer(arguments)
% ANSWER  What the command prints to arguments (text, quoted already).
kept = [tempname() '.txt'];
try
    call([arguments ' >' quoted(kept)], false);
    text = fileread(kept);
catch problem
    if exist(kept, 'file')
        delete(kept);
    end
    rethrow(problem);
end
delete(kept);
end
